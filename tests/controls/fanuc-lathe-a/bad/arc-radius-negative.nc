(expected: 4:15 R-6 is negative)
T0101 S500 M3 F.2
G0 X40. Z-10.
G2 X40. Z-20. R-6.
M30
