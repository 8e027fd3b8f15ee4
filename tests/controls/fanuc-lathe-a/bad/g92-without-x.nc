(expected: 4:1 X missing in G92)
T0101 S500 M3 F.2
G0 X50. Z5.
G92 Z-20. F1.
M30
