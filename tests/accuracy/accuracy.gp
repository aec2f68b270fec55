set terminal svg size 900,560 font 'sans,12' background 'white'
set output 'accuracy.svg'
set logscale y
set xlabel 'instructions of a pixel'
set ylabel 'largest texel error [texels]'
set format y '10^{%T}'
set grid
set key outside below left Left reverse
set offsets graph 0.05, graph 0.15, graph 0.05, graph 0.05
$all << END
19.1079 5.9605e-08 -1 "exact"
19.0123 5.9605e-08 0.000001 "0.000001"
19.0640 5.9605e-08 0.0001 "0.0001"
19.0066 9.9416e-03 0.01 "0.01"
18.0297 9.9986e-02 0.1 "0.1"
17.6158 2.5000e-01 0.25 "0.25"
17.4160 4.9998e-01 0.5 "0.5"
17.1203 9.9982e-01 1 "1"
16.9394 3.9998e+00 4 "4"
21.4529 1.2795e+02 -1 "span=4"
21.4761 1.2800e+02 -1 ""
21.4759 1.2800e+02 -1 ""
21.5819 1.2800e+02 -1 ""
29.2034 2.2290e-03 -1 "number=float"
33.0532 2.6829e-03 -1 "number=fixed"
63.8066 1.2776e+02 -1 "number=vanilla"
END
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $all using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $all using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $all using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set terminal svg size 1100,1440 font 'sans,10' background 'white'
set output 'scenes.svg'
unset key
$scene_0 << END
12.1155 2.9802e-08 -1 "exact"
12.1891 2.9802e-08 0.000001 "0.000001"
12.0018 2.9802e-08 0.0001 "0.0001"
11.9363 2.9802e-08 0.01 "0.01"
11.2093 2.9802e-08 0.1 "0.1"
10.9824 2.4989e-01 0.25 "0.25"
10.6166 4.9976e-01 0.5 "0.5"
10.5341 9.9886e-01 1 "1"
10.0278 3.9993e+00 4 "4"
13.5429 1.2750e+02 -1 "span=4"
13.4859 1.2793e+02 -1 ""
13.3367 1.2800e+02 -1 ""
13.6119 1.2800e+02 -1 ""
20.2824 3.0020e-04 -1 "number=float"
23.1790 2.1319e-03 -1 "number=fixed"
47.4771 1.2711e+02 -1 "number=vanilla"
END
$scene_1 << END
26.4393 5.9605e-08 -1 "exact"
26.3979 5.9605e-08 0.000001 "0.000001"
26.2529 5.9605e-08 0.0001 "0.0001"
26.0970 5.9605e-08 0.01 "0.01"
26.1589 9.9986e-02 0.1 "0.1"
26.4074 2.4920e-01 0.25 "0.25"
26.5431 4.9785e-01 0.5 "0.5"
26.3727 9.9740e-01 1 "1"
26.7661 3.9952e+00 4 "4"
29.9648 1.2795e+02 -1 "span=4"
29.8432 1.2800e+02 -1 ""
29.9301 1.2800e+02 -1 ""
30.1982 1.2800e+02 -1 ""
34.0878 1.4220e-03 -1 "number=float"
36.5475 2.6829e-03 -1 "number=fixed"
56.2307 1.2776e+02 -1 "number=vanilla"
END
$scene_2 << END
18.3591 4.4492e-08 -1 "exact"
18.1632 4.4492e-08 0.000001 "0.000001"
18.1971 4.4492e-08 0.0001 "0.0001"
18.3614 4.4492e-08 0.01 "0.01"
17.9435 9.9943e-02 0.1 "0.1"
17.7798 2.4890e-01 0.25 "0.25"
17.5076 4.9966e-01 0.5 "0.5"
17.5719 9.9935e-01 1 "1"
17.1489 3.9931e+00 4 "4"
21.2415 1.1811e+02 -1 "span=4"
21.3454 1.2797e+02 -1 ""
21.3450 1.2799e+02 -1 ""
21.3916 1.2800e+02 -1 ""
31.9268 4.3944e-04 -1 "number=float"
36.7953 1.4323e-03 -1 "number=fixed"
74.5898 6.3959e+01 -1 "number=vanilla"
END
$scene_3 << END
24.5218 4.4703e-08 -1 "exact"
24.3357 4.4703e-08 0.000001 "0.000001"
24.5150 4.4703e-08 0.0001 "0.0001"
24.4269 4.4703e-08 0.01 "0.01"
24.3496 4.4703e-08 0.1 "0.1"
24.1733 4.4703e-08 0.25 "0.25"
24.5325 3.8992e-01 0.5 "0.5"
24.3095 9.9846e-01 1 "1"
24.2973 3.9871e+00 4 "4"
27.4151 3.8865e+01 -1 "span=4"
27.7382 1.2308e+02 -1 "span=8"
27.3954 1.2798e+02 -1 ""
27.7896 1.2800e+02 -1 ""
38.5608 3.0752e-04 -1 "number=float"
43.5267 1.4386e-03 -1 "number=fixed"
82.9133 5.8608e+01 -1 "number=vanilla"
END
$scene_4 << END
20.8404 4.4703e-08 -1 "exact"
20.4323 4.4703e-08 0.000001 "0.000001"
20.7325 4.4703e-08 0.0001 "0.0001"
20.8023 4.4703e-08 0.01 "0.01"
19.7875 4.4703e-08 0.1 "0.1"
19.4819 2.5000e-01 0.25 "0.25"
19.3850 4.9871e-01 0.5 "0.5"
19.2271 9.9970e-01 1 "1"
19.3896 3.9989e+00 4 "4"
22.9536 6.3940e+01 -1 "span=4"
22.9246 1.2594e+02 -1 "span=8"
23.3917 1.2799e+02 -1 ""
23.0465 1.2800e+02 -1 ""
30.2376 2.2290e-03 -1 "number=float"
33.7083 1.4710e-03 -1 "number=fixed"
59.6658 1.1298e+02 -1 "number=vanilla"
END
$scene_5 << END
11.0185 2.9793e-08 -1 "exact"
10.9495 2.9793e-08 0.000001 "0.000001"
11.0450 2.9793e-08 0.0001 "0.0001"
10.6332 9.8550e-03 0.01 "0.01"
8.0501 9.9653e-02 0.1 "0.1"
7.3195 2.4984e-01 0.25 "0.25"
6.6107 4.9998e-01 0.5 "0.5"
5.8581 9.9955e-01 1 "1"
5.4278 3.9994e+00 4 "4"
12.3394 3.1992e+01 -1 "span=4"
12.4256 3.1994e+01 -1 ""
12.1500 4.0292e+01 -1 ""
12.2455 4.8833e+01 -1 ""
16.3806 2.5750e-04 -1 "number=float"
18.6739 1.5564e-03 -1 "number=fixed"
38.3369 6.1107e+01 -1 "number=vanilla"
END
$scene_6 << END
20.4605 2.8699e-08 -1 "exact"
20.6181 2.8699e-08 0.000001 "0.000001"
20.7039 2.8699e-08 0.0001 "0.0001"
20.7889 9.9416e-03 0.01 "0.01"
18.7088 9.9955e-02 0.1 "0.1"
17.1664 2.4997e-01 0.25 "0.25"
16.7161 4.9997e-01 0.5 "0.5"
15.9688 9.9982e-01 1 "1"
15.5187 3.9998e+00 4 "4"
22.7129 3.8605e+01 -1 "span=4"
22.5696 5.4678e+01 -1 ""
22.7823 5.4678e+01 -1 ""
22.7901 6.0564e+01 -1 ""
32.9480 1.3868e-04 -1 "number=float"
38.9413 1.3543e-03 -1 "number=fixed"
87.4327 6.3688e+01 -1 "number=vanilla"
END
set multiplot layout 4,2
set title 'rooms' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_0 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_0 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_0 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'enfilade' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_1 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_1 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_1 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'hut' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_2 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_2 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_2 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'quarter_turn' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_3 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_3 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_3 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'facing_doors' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_4 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_4 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_4 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'e1m1' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_5 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_5 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_5 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set title 'map01' noenhanced
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $scene_6 using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $scene_6 using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $scene_6 using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
unset multiplot
