(expected: 4:12 radius 1 mm too small)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X40. Z0 R1.
M30
