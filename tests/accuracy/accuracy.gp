set terminal svg size 900,560 font 'sans,12' background 'white'
set output '/work/main/tests/accuracy/accuracy.svg'
set logscale y
set xlabel 'instructions of a pixel'
set ylabel 'largest texel error [texels]'
set format y '10^{%T}'
set grid
set key outside below left Left reverse
set offsets graph 0.05, graph 0.15, graph 0.05, graph 0.05
$all << END
19.0557 5.9605e-08 -1 "exact"
19.1509 5.9605e-08 0.000001 "0.000001"
19.0659 5.9605e-08 0.0001 "0.0001"
19.0362 9.9416e-03 0.01 "0.01"
18.1647 9.9986e-02 0.1 "0.1"
17.5360 2.5000e-01 0.25 "0.25"
17.2583 4.9998e-01 0.5 "0.5"
17.1402 9.9982e-01 1 "1"
16.8989 3.9998e+00 4 "4"
21.3295 1.2795e+02 -1 "span=4"
21.4404 1.2800e+02 -1 ""
21.3146 1.2800e+02 -1 ""
21.4487 1.2800e+02 -1 ""
29.1888 2.2290e-03 -1 "number=float"
33.1679 2.6829e-03 -1 "number=fixed"
63.7784 1.2776e+02 -1 "number=vanilla"
END
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $all using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $all using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $all using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set terminal svg size 1100,1440 font 'sans,10' background 'white'
set output '/work/main/tests/accuracy/scenes.svg'
unset key
$scene_0 << END
12.1437 2.9802e-08 -1 "exact"
12.1946 2.9802e-08 0.000001 "0.000001"
12.1907 2.9802e-08 0.0001 "0.0001"
12.0242 2.9802e-08 0.01 "0.01"
11.6042 2.9802e-08 0.1 "0.1"
10.8898 2.4989e-01 0.25 "0.25"
10.6681 4.9976e-01 0.5 "0.5"
10.8673 9.9886e-01 1 "1"
10.4539 3.9993e+00 4 "4"
13.2639 1.2750e+02 -1 "span=4"
13.3686 1.2793e+02 -1 ""
13.1901 1.2800e+02 -1 ""
13.5123 1.2800e+02 -1 ""
20.1264 3.0020e-04 -1 "number=float"
23.4137 2.1319e-03 -1 "number=fixed"
47.4131 1.2711e+02 -1 "number=vanilla"
END
$scene_1 << END
26.3052 5.9605e-08 -1 "exact"
26.3815 5.9605e-08 0.000001 "0.000001"
26.3008 5.9605e-08 0.0001 "0.0001"
26.3158 5.9605e-08 0.01 "0.01"
26.4116 9.9986e-02 0.1 "0.1"
26.2685 2.4920e-01 0.25 "0.25"
26.4016 4.9785e-01 0.5 "0.5"
26.4538 9.9740e-01 1 "1"
26.6677 3.9952e+00 4 "4"
29.8566 1.2795e+02 -1 "span=4"
29.9038 1.2800e+02 -1 ""
29.9556 1.2800e+02 -1 ""
30.0517 1.2800e+02 -1 ""
34.0437 1.4220e-03 -1 "number=float"
36.4040 2.6829e-03 -1 "number=fixed"
56.2347 1.2776e+02 -1 "number=vanilla"
END
$scene_2 << END
18.4770 4.4492e-08 -1 "exact"
18.4296 4.4492e-08 0.000001 "0.000001"
18.2608 4.4492e-08 0.0001 "0.0001"
18.2598 4.4492e-08 0.01 "0.01"
17.9668 9.9943e-02 0.1 "0.1"
17.7770 2.4890e-01 0.25 "0.25"
17.7667 4.9966e-01 0.5 "0.5"
17.3407 9.9935e-01 1 "1"
17.2920 3.9931e+00 4 "4"
21.2146 1.1811e+02 -1 "span=4"
21.2073 1.2797e+02 -1 ""
21.2373 1.2799e+02 -1 ""
21.2779 1.2800e+02 -1 ""
32.0615 4.3944e-04 -1 "number=float"
37.0128 1.4323e-03 -1 "number=fixed"
74.4919 6.3959e+01 -1 "number=vanilla"
END
$scene_3 << END
24.4272 4.4703e-08 -1 "exact"
24.4552 4.4703e-08 0.000001 "0.000001"
24.2879 4.4703e-08 0.0001 "0.0001"
24.5437 4.4703e-08 0.01 "0.01"
24.2984 4.4703e-08 0.1 "0.1"
24.6467 4.4703e-08 0.25 "0.25"
24.3176 3.8992e-01 0.5 "0.5"
24.4926 9.9846e-01 1 "1"
24.4298 3.9871e+00 4 "4"
27.4195 3.8865e+01 -1 "span=4"
27.4910 1.2308e+02 -1 "span=8"
27.5029 1.2798e+02 -1 ""
27.5365 1.2800e+02 -1 ""
38.6185 3.0752e-04 -1 "number=float"
43.9423 1.4386e-03 -1 "number=fixed"
82.7841 5.8608e+01 -1 "number=vanilla"
END
$scene_4 << END
20.4952 4.4703e-08 -1 "exact"
20.8620 4.4703e-08 0.000001 "0.000001"
20.7724 4.4703e-08 0.0001 "0.0001"
20.7777 4.4703e-08 0.01 "0.01"
20.1067 4.4703e-08 0.1 "0.1"
19.2338 2.5000e-01 0.25 "0.25"
19.0933 4.9871e-01 0.5 "0.5"
19.2493 9.9970e-01 1 "1"
18.9818 3.9989e+00 4 "4"
23.0702 6.3940e+01 -1 "span=4"
23.0800 1.2594e+02 -1 "span=8"
22.7809 1.2799e+02 -1 ""
23.0787 1.2800e+02 -1 ""
30.1778 2.2290e-03 -1 "number=float"
33.5705 1.4710e-03 -1 "number=fixed"
59.6478 1.1298e+02 -1 "number=vanilla"
END
$scene_5 << END
11.1074 2.9793e-08 -1 "exact"
10.9541 2.9793e-08 0.000001 "0.000001"
10.9543 2.9793e-08 0.0001 "0.0001"
10.6400 9.8550e-03 0.01 "0.01"
8.1267 9.9653e-02 0.1 "0.1"
6.9016 2.4984e-01 0.25 "0.25"
6.1426 4.9998e-01 0.5 "0.5"
5.7928 9.9955e-01 1 "1"
4.8355 3.9994e+00 4 "4"
11.9944 3.1992e+01 -1 "span=4"
12.3159 3.1994e+01 -1 ""
12.1358 4.0292e+01 -1 ""
12.2260 4.8833e+01 -1 ""
16.3919 2.5750e-04 -1 "number=float"
18.8712 1.5564e-03 -1 "number=fixed"
38.5337 6.1107e+01 -1 "number=vanilla"
END
$scene_6 << END
20.4341 2.8699e-08 -1 "exact"
20.7796 2.8699e-08 0.000001 "0.000001"
20.6946 2.8699e-08 0.0001 "0.0001"
20.6926 9.9416e-03 0.01 "0.01"
18.6383 9.9955e-02 0.1 "0.1"
17.0344 2.4997e-01 0.25 "0.25"
16.4187 4.9997e-01 0.5 "0.5"
15.7846 9.9982e-01 1 "1"
15.6313 3.9998e+00 4 "4"
22.4870 3.8605e+01 -1 "span=4"
22.7165 5.4678e+01 -1 ""
22.3997 5.4678e+01 -1 ""
22.4578 6.0564e+01 -1 ""
32.9018 1.3868e-04 -1 "number=float"
38.9608 1.3543e-03 -1 "number=fixed"
87.3432 6.3688e+01 -1 "number=vanilla"
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
