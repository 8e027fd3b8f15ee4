(expected: 4:8 G53 with incremental coordinates)
T0101 S500 M3 F.2
G0 X50. Z5.
G53 G0 U5.
M30
