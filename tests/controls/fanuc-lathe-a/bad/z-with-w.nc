(expected: 4:4 Z and W in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 Z-1. W2.
M30
