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
19.0821 5.9605e-08 -1 "exact"
19.0855 5.9605e-08 0.000001 "0.000001"
19.1076 5.9605e-08 0.0001 "0.0001"
19.0228 9.9416e-03 0.01 "0.01"
18.0623 9.9986e-02 0.1 "0.1"
17.6504 2.5000e-01 0.25 "0.25"
17.2989 4.9998e-01 0.5 "0.5"
17.0884 9.9982e-01 1 "1"
16.8024 3.9998e+00 4 "4"
21.3804 1.2795e+02 -1 "span=4"
21.3570 1.2800e+02 -1 ""
21.4322 1.2800e+02 -1 ""
21.4369 1.2800e+02 -1 ""
29.0551 2.2290e-03 -1 "number=float"
33.0379 2.6829e-03 -1 "number=fixed"
63.7472 1.2776e+02 -1 "number=vanilla"
END
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $all using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $all using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $all using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set terminal svg size 1100,1440 font 'sans,10' background 'white'
set output 'scenes.svg'
unset key
$scene_0 << END
12.1458 2.9802e-08 -1 "exact"
12.1941 2.9802e-08 0.000001 "0.000001"
12.0974 2.9802e-08 0.0001 "0.0001"
12.0081 2.9802e-08 0.01 "0.01"
11.4607 2.9802e-08 0.1 "0.1"
11.1406 2.4989e-01 0.25 "0.25"
10.4793 4.9976e-01 0.5 "0.5"
10.3501 9.9886e-01 1 "1"
10.0839 3.9993e+00 4 "4"
13.3345 1.2750e+02 -1 "span=4"
13.2717 1.2793e+02 -1 ""
13.2794 1.2800e+02 -1 ""
13.4714 1.2800e+02 -1 ""
19.9670 3.0020e-04 -1 "number=float"
23.1779 2.1319e-03 -1 "number=fixed"
47.3196 1.2711e+02 -1 "number=vanilla"
END
$scene_1 << END
26.5128 5.9605e-08 -1 "exact"
26.2666 5.9605e-08 0.000001 "0.000001"
26.4083 5.9605e-08 0.0001 "0.0001"
26.3219 5.9605e-08 0.01 "0.01"
26.2764 9.9986e-02 0.1 "0.1"
26.4620 2.4920e-01 0.25 "0.25"
26.3346 4.9785e-01 0.5 "0.5"
26.4983 9.9740e-01 1 "1"
26.7566 3.9952e+00 4 "4"
29.8750 1.2795e+02 -1 "span=4"
29.6447 1.2800e+02 -1 ""
29.9565 1.2800e+02 -1 ""
29.9887 1.2800e+02 -1 ""
33.9873 1.4220e-03 -1 "number=float"
36.2499 2.6829e-03 -1 "number=fixed"
56.3550 1.2776e+02 -1 "number=vanilla"
END
$scene_2 << END
18.4677 4.4492e-08 -1 "exact"
18.3448 4.4492e-08 0.000001 "0.000001"
18.2606 4.4492e-08 0.0001 "0.0001"
18.5628 4.4492e-08 0.01 "0.01"
18.0361 9.9943e-02 0.1 "0.1"
17.8531 2.4890e-01 0.25 "0.25"
17.6121 4.9966e-01 0.5 "0.5"
17.5430 9.9935e-01 1 "1"
17.2899 3.9931e+00 4 "4"
21.0442 1.1811e+02 -1 "span=4"
21.2243 1.2797e+02 -1 ""
21.1852 1.2799e+02 -1 ""
21.2631 1.2800e+02 -1 ""
31.9587 4.3944e-04 -1 "number=float"
36.9253 1.4323e-03 -1 "number=fixed"
74.5592 6.3959e+01 -1 "number=vanilla"
END
$scene_3 << END
24.4262 4.4703e-08 -1 "exact"
24.4552 4.4703e-08 0.000001 "0.000001"
24.4612 4.4703e-08 0.0001 "0.0001"
24.3058 4.4703e-08 0.01 "0.01"
24.2017 4.4703e-08 0.1 "0.1"
24.4424 4.4703e-08 0.25 "0.25"
24.3024 3.8992e-01 0.5 "0.5"
24.4635 9.9846e-01 1 "1"
24.6565 3.9871e+00 4 "4"
27.4777 3.8865e+01 -1 "span=4"
27.4895 1.2308e+02 -1 "span=8"
27.5040 1.2798e+02 -1 ""
27.5363 1.2800e+02 -1 ""
38.6166 3.0752e-04 -1 "number=float"
43.6810 1.4386e-03 -1 "number=fixed"
82.7866 5.8608e+01 -1 "number=vanilla"
END
$scene_4 << END
20.5286 4.4703e-08 -1 "exact"
20.5284 4.4703e-08 0.000001 "0.000001"
20.4922 4.4703e-08 0.0001 "0.0001"
20.4080 4.4703e-08 0.01 "0.01"
19.8823 4.4703e-08 0.1 "0.1"
19.6679 2.5000e-01 0.25 "0.25"
19.2793 4.9871e-01 0.5 "0.5"
18.9402 9.9970e-01 1 "1"
19.1069 3.9989e+00 4 "4"
23.1387 6.3940e+01 -1 "span=4"
23.1444 1.2594e+02 -1 "span=8"
23.1614 1.2799e+02 -1 ""
22.8168 1.2800e+02 -1 ""
30.1332 2.2290e-03 -1 "number=float"
33.2375 1.4710e-03 -1 "number=fixed"
59.7096 1.1298e+02 -1 "number=vanilla"
END
$scene_5 << END
11.0133 2.9793e-08 -1 "exact"
11.1008 2.9793e-08 0.000001 "0.000001"
11.1234 2.9793e-08 0.0001 "0.0001"
10.7111 9.8550e-03 0.01 "0.01"
7.8948 9.9653e-02 0.1 "0.1"
6.7517 2.4984e-01 0.25 "0.25"
6.6130 4.9998e-01 0.5 "0.5"
5.6524 9.9955e-01 1 "1"
4.9240 3.9994e+00 4 "4"
12.1658 3.1992e+01 -1 "span=4"
12.3628 3.1994e+01 -1 ""
12.3035 4.0292e+01 -1 ""
12.2457 4.8833e+01 -1 ""
16.0810 2.5750e-04 -1 "number=float"
18.8710 1.5564e-03 -1 "number=fixed"
38.4075 6.1107e+01 -1 "number=vanilla"
END
$scene_6 << END
20.4804 2.8699e-08 -1 "exact"
20.7084 2.8699e-08 0.000001 "0.000001"
20.9100 2.8699e-08 0.0001 "0.0001"
20.8421 9.9416e-03 0.01 "0.01"
18.6840 9.9955e-02 0.1 "0.1"
17.2352 2.4997e-01 0.25 "0.25"
16.4712 4.9997e-01 0.5 "0.5"
16.1715 9.9982e-01 1 "1"
14.7993 3.9998e+00 4 "4"
22.6272 3.8605e+01 -1 "span=4"
22.3615 5.4678e+01 -1 ""
22.6354 5.4678e+01 -1 ""
22.7362 6.0564e+01 -1 ""
32.6416 1.3868e-04 -1 "number=float"
39.1225 1.3543e-03 -1 "number=fixed"
87.0928 6.3688e+01 -1 "number=vanilla"
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
