(expected: 4:10 the two lines run back along each other: there is no corner)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 Z-20. ,C1.
Z-10.
M30
