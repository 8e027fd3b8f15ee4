(expected: 4:9 there is a block after)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X40. ; Z1.
M30
