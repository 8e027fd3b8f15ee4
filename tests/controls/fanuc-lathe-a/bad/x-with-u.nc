(expected: 4:4 X and U in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X40. U2.
M30
