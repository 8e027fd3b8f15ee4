(expected: 4:1 K is missing in G34)
T0101 S500 M3 F.2
G0 X50. Z5.
G34 Z-20. F2.
M30
