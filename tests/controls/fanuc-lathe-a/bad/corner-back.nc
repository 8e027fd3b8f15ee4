(expected: 4:9 the second line runs back along the first: there is no corner)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,R3.
X30.
M30
