(expected: 4:10 the second line runs back along the first: there is no corner)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 Z-20. ,C1.
Z-10.
M30
