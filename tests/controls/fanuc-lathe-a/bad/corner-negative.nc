(expected: 4:11 ,C-3 is not the size of a corner)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X20. ,C-3.
Z-9.
M30
