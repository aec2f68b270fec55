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
16.0011 5.9605e-08 -1 "exact"
16.0666 5.9605e-08 0.000001 "0.000001"
16.0666 5.9605e-08 0.0001 "0.0001"
16.0115 9.9314e-03 0.01 "0.01"
15.1021 9.9986e-02 0.1 "0.1"
14.5307 2.5000e-01 0.25 "0.25"
14.2405 4.9996e-01 0.5 "0.5"
14.0469 9.9992e-01 1 "1"
13.8471 3.9999e+00 4 "4"
19.1542 1.2795e+02 -1 "span=4"
19.1689 1.2800e+02 -1 ""
19.1918 1.2800e+02 -1 ""
19.2269 1.2800e+02 -1 ""
26.9873 2.2290e-03 -1 "number=float"
30.9349 2.6829e-03 -1 "number=fixed"
62.3654 1.2784e+02 -1 "number=vanilla"
END
plot 1.0/512 with lines dt 2 lc rgb '#808080' title 'Direct3D: 8 bits of a texel', 0.01 with lines dt 3 lc rgb '#808080' title 'Vulkan, OpenGL ES: 1e-5 of 1024 texels', $all using 1:($3 > 0 ? $3 : NaN) with points pt 6 ps 1.2 lc rgb '#c03030' title 'promised: no texel is off by more', $all using 1:2 with points pt 7 ps 0.8 lc rgb '#204a87' title 'measured: the worst texel', $all using 1:($3 > 0 ? $3 : $2):4 with labels left offset 0.9,0 font 'sans,9' notitle
set terminal svg size 1100,1440 font 'sans,10' background 'white'
set output 'scenes.svg'
unset key
$scene_0 << END
11.1026 2.9802e-08 -1 "exact"
11.1027 2.9802e-08 0.000001 "0.000001"
11.1027 2.9802e-08 0.0001 "0.0001"
11.1027 2.9802e-08 0.01 "0.01"
10.4357 2.9802e-08 0.1 "0.1"
10.0079 2.4989e-01 0.25 "0.25"
9.7637 4.9976e-01 0.5 "0.5"
9.5644 9.9886e-01 1 "1"
9.2946 3.9993e+00 4 "4"
12.5255 1.2750e+02 -1 "span=4"
12.5338 1.2793e+02 -1 ""
12.5490 1.2800e+02 -1 ""
12.5768 1.2800e+02 -1 ""
19.3735 3.0020e-04 -1 "number=float"
22.4890 2.1319e-03 -1 "number=fixed"
47.1529 1.1263e+02 -1 "number=vanilla"
END
$scene_1 << END
19.9182 5.9605e-08 -1 "exact"
19.9184 5.9605e-08 0.000001 "0.000001"
19.9183 5.9605e-08 0.0001 "0.0001"
19.9184 5.9605e-08 0.01 "0.01"
19.9843 9.9986e-02 0.1 "0.1"
19.9842 2.4920e-01 0.25 "0.25"
19.9932 4.9785e-01 0.5 "0.5"
20.0556 9.9740e-01 1 "1"
20.2772 3.9952e+00 4 "4"
25.0485 1.2795e+02 -1 "span=4"
25.0899 1.2800e+02 -1 ""
25.1410 1.2800e+02 -1 ""
25.1993 1.2800e+02 -1 ""
29.3885 1.4220e-03 -1 "number=float"
31.8590 2.6829e-03 -1 "number=fixed"
53.3523 1.2784e+02 -1 "number=vanilla"
END
$scene_2 << END
15.2709 4.4492e-08 -1 "exact"
15.2711 4.4492e-08 0.000001 "0.000001"
15.2711 4.4492e-08 0.0001 "0.0001"
15.2710 4.4492e-08 0.01 "0.01"
15.0510 9.9943e-02 0.1 "0.1"
14.6900 2.4890e-01 0.25 "0.25"
14.5083 4.9966e-01 0.5 "0.5"
14.3625 9.9935e-01 1 "1"
14.2096 3.9931e+00 4 "4"
19.3328 1.1811e+02 -1 "span=4"
19.3403 1.2797e+02 -1 ""
19.3530 1.2799e+02 -1 ""
19.3776 1.2800e+02 -1 ""
30.1643 4.3944e-04 -1 "number=float"
35.0422 1.4323e-03 -1 "number=fixed"
73.1961 6.3959e+01 -1 "number=vanilla"
END
$scene_3 << END
20.9631 4.4703e-08 -1 "exact"
20.9634 4.4703e-08 0.000001 "0.000001"
20.9633 4.4703e-08 0.0001 "0.0001"
20.9634 4.4703e-08 0.01 "0.01"
20.9837 4.4703e-08 0.1 "0.1"
20.9837 4.4703e-08 0.25 "0.25"
20.9837 3.8992e-01 0.5 "0.5"
21.0051 9.9846e-01 1 "1"
20.9972 3.9871e+00 4 "4"
25.2942 3.8865e+01 -1 "span=4"
25.3024 1.2308e+02 -1 "span=8"
25.3171 1.2798e+02 -1 ""
25.3444 1.2800e+02 -1 ""
36.4735 3.0752e-04 -1 "number=float"
41.5357 1.4386e-03 -1 "number=fixed"
81.2035 6.1765e+01 -1 "number=vanilla"
END
$scene_4 << END
17.6879 4.4703e-08 -1 "exact"
17.6881 4.4703e-08 0.000001 "0.000001"
17.6880 4.4703e-08 0.0001 "0.0001"
17.6880 4.4703e-08 0.01 "0.01"
16.9664 4.4703e-08 0.1 "0.1"
16.5340 2.5000e-01 0.25 "0.25"
16.2834 4.9871e-01 0.5 "0.5"
16.1443 9.9970e-01 1 "1"
16.0357 3.9989e+00 4 "4"
21.6296 6.3940e+01 -1 "span=4"
21.6377 1.2594e+02 -1 "span=8"
21.6530 1.2799e+02 -1 ""
21.6804 1.2800e+02 -1 ""
28.7824 2.2290e-03 -1 "number=float"
32.1520 1.4710e-03 -1 "number=fixed"
58.8720 1.1298e+02 -1 "number=vanilla"
END
$scene_5 << END
10.3576 2.9706e-08 -1 "exact"
10.4852 2.9706e-08 0.000001 "0.000001"
10.4852 2.9706e-08 0.0001 "0.0001"
10.0999 9.9314e-03 0.01 "0.01"
7.3862 9.9958e-02 0.1 "0.1"
6.2025 2.4999e-01 0.25 "0.25"
5.5623 4.9979e-01 0.5 "0.5"
5.0907 9.9992e-01 1 "1"
4.6957 3.9999e+00 4 "4"
11.5445 3.1995e+01 -1 "span=4"
11.5545 3.1998e+01 -1 ""
11.5739 4.5012e+01 -1 ""
11.6081 6.1431e+01 -1 ""
15.6289 2.6435e-04 -1 "number=float"
18.1550 1.5907e-03 -1 "number=fixed"
38.4177 1.8310e+01 -1 "number=vanilla"
END
$scene_6 << END
16.7071 2.8833e-08 -1 "exact"
17.0374 2.8833e-08 0.000001 "0.000001"
17.0373 2.8833e-08 0.0001 "0.0001"
17.0373 9.8802e-03 0.01 "0.01"
14.9073 9.9737e-02 0.1 "0.1"
13.3128 2.4986e-01 0.25 "0.25"
12.5892 4.9996e-01 0.5 "0.5"
12.1060 9.9961e-01 1 "1"
11.4199 3.9998e+00 4 "4"
18.7042 5.8388e+01 -1 "span=4"
18.7239 5.1158e+01 -1 ""
18.7559 5.1158e+01 -1 ""
18.8015 6.0121e+01 -1 ""
29.1000 1.6075e-04 -1 "number=float"
35.3114 1.3430e-03 -1 "number=fixed"
84.3634 3.7394e+01 -1 "number=vanilla"
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
