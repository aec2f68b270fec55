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
19.0523 5.9605e-08 -1 "exact"
19.0974 5.9605e-08 0.000001 "0.000001"
19.0975 5.9605e-08 0.0001 "0.0001"
19.0428 9.9314e-03 0.01 "0.01"
18.1417 9.9986e-02 0.1 "0.1"
17.5780 2.5000e-01 0.25 "0.25"
17.2910 4.9996e-01 0.5 "0.5"
17.0979 9.9992e-01 1 "1"
16.8973 3.9999e+00 4 "4"
21.3731 1.2795e+02 -1 "span=4"
21.3901 1.2800e+02 -1 ""
21.4167 1.2800e+02 -1 ""
21.4573 1.2800e+02 -1 ""
29.1556 2.2290e-03 -1 "number=float"
33.1032 2.6829e-03 -1 "number=fixed"
64.5332 1.2784e+02 -1 "number=vanilla"
END
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $all using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $all using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $all using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set terminal svg size 1100,1440 font 'sans,10' background 'white'
set output 'scenes.svg'
unset key
$scene_0 << END
12.0233 2.9802e-08 -1 "exact"
12.0234 2.9802e-08 0.000001 "0.000001"
12.0234 2.9802e-08 0.0001 "0.0001"
12.0234 2.9802e-08 0.01 "0.01"
11.3719 2.9802e-08 0.1 "0.1"
10.9544 2.4989e-01 0.25 "0.25"
10.7158 4.9976e-01 0.5 "0.5"
10.5213 9.9886e-01 1 "1"
10.2537 3.9993e+00 4 "4"
13.3354 1.2750e+02 -1 "span=4"
13.3451 1.2793e+02 -1 ""
13.3628 1.2800e+02 -1 ""
13.3953 1.2800e+02 -1 ""
20.1448 3.0020e-04 -1 "number=float"
23.2602 2.1319e-03 -1 "number=fixed"
47.9243 1.1263e+02 -1 "number=vanilla"
END
$scene_1 << END
26.6470 5.9605e-08 -1 "exact"
26.6471 5.9605e-08 0.000001 "0.000001"
26.6471 5.9605e-08 0.0001 "0.0001"
26.6471 5.9605e-08 0.01 "0.01"
26.7055 9.9986e-02 0.1 "0.1"
26.7055 2.4920e-01 0.25 "0.25"
26.7145 4.9785e-01 0.5 "0.5"
26.7731 9.9740e-01 1 "1"
26.9946 3.9952e+00 4 "4"
30.0192 1.2795e+02 -1 "span=4"
30.0668 1.2800e+02 -1 ""
30.1259 1.2800e+02 -1 ""
30.1936 1.2800e+02 -1 ""
34.2688 1.4220e-03 -1 "number=float"
36.7393 2.6829e-03 -1 "number=fixed"
58.2315 1.2784e+02 -1 "number=vanilla"
END
$scene_2 << END
18.3725 4.4492e-08 -1 "exact"
18.3726 4.4492e-08 0.000001 "0.000001"
18.3727 4.4492e-08 0.0001 "0.0001"
18.3726 4.4492e-08 0.01 "0.01"
18.1597 9.9943e-02 0.1 "0.1"
17.8165 2.4890e-01 0.25 "0.25"
17.6389 4.9966e-01 0.5 "0.5"
17.4967 9.9935e-01 1 "1"
17.3472 3.9931e+00 4 "4"
21.2009 1.1811e+02 -1 "span=4"
21.2095 1.2797e+02 -1 ""
21.2242 1.2799e+02 -1 ""
21.2522 1.2800e+02 -1 ""
31.9976 4.3944e-04 -1 "number=float"
36.8756 1.4323e-03 -1 "number=fixed"
75.0291 6.3959e+01 -1 "number=vanilla"
END
$scene_3 << END
24.3583 4.4703e-08 -1 "exact"
24.3585 4.4703e-08 0.000001 "0.000001"
24.3585 4.4703e-08 0.0001 "0.0001"
24.3585 4.4703e-08 0.01 "0.01"
24.3726 4.4703e-08 0.1 "0.1"
24.3726 4.4703e-08 0.25 "0.25"
24.3726 3.8992e-01 0.5 "0.5"
24.3943 9.9846e-01 1 "1"
24.3866 3.9871e+00 4 "4"
27.4735 3.8865e+01 -1 "span=4"
27.4829 1.2308e+02 -1 "span=8"
27.5000 1.2798e+02 -1 ""
27.5316 1.2800e+02 -1 ""
38.6143 3.0752e-04 -1 "number=float"
43.6765 1.4386e-03 -1 "number=fixed"
83.3431 6.1765e+01 -1 "number=vanilla"
END
$scene_4 << END
20.5888 4.4703e-08 -1 "exact"
20.5889 4.4703e-08 0.000001 "0.000001"
20.5889 4.4703e-08 0.0001 "0.0001"
20.5889 4.4703e-08 0.01 "0.01"
19.9020 4.4703e-08 0.1 "0.1"
19.4829 2.5000e-01 0.25 "0.25"
19.2383 4.9871e-01 0.5 "0.5"
19.1025 9.9970e-01 1 "1"
18.9965 3.9989e+00 4 "4"
22.9473 6.3940e+01 -1 "span=4"
22.9569 1.2594e+02 -1 "span=8"
22.9745 1.2799e+02 -1 ""
23.0063 1.2800e+02 -1 ""
30.0581 2.2290e-03 -1 "number=float"
33.4277 1.4710e-03 -1 "number=fixed"
60.1470 1.1298e+02 -1 "number=vanilla"
END
$scene_5 << END
10.9159 2.9706e-08 -1 "exact"
11.0044 2.9706e-08 0.000001 "0.000001"
11.0044 2.9706e-08 0.0001 "0.0001"
10.6219 9.9314e-03 0.01 "0.01"
7.9137 9.9958e-02 0.1 "0.1"
6.7369 2.4999e-01 0.25 "0.25"
6.0949 4.9979e-01 0.5 "0.5"
5.6189 9.9992e-01 1 "1"
5.2204 3.9999e+00 4 "4"
12.1580 3.1995e+01 -1 "span=4"
12.1696 3.1998e+01 -1 ""
12.1922 4.5012e+01 -1 ""
12.2322 6.1431e+01 -1 ""
16.1943 2.6435e-04 -1 "number=float"
18.7205 1.5907e-03 -1 "number=fixed"
38.9831 1.8310e+01 -1 "number=vanilla"
END
$scene_6 << END
20.4604 2.8833e-08 -1 "exact"
20.6872 2.8833e-08 0.000001 "0.000001"
20.6872 2.8833e-08 0.0001 "0.0001"
20.6872 9.8802e-03 0.01 "0.01"
18.5668 9.9737e-02 0.1 "0.1"
16.9774 2.4986e-01 0.25 "0.25"
16.2620 4.9996e-01 0.5 "0.5"
15.7785 9.9961e-01 1 "1"
15.0824 3.9998e+00 4 "4"
22.4771 5.8388e+01 -1 "span=4"
22.4997 5.1158e+01 -1 ""
22.5370 5.1158e+01 -1 ""
22.5901 6.0121e+01 -1 ""
32.8110 1.6075e-04 -1 "number=float"
39.0225 1.3430e-03 -1 "number=fixed"
88.0744 3.7394e+01 -1 "number=vanilla"
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
