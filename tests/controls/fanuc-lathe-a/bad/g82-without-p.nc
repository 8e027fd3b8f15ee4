(expected: 4 P is missing in G82)
T0101 S500 M3 F.2
G0 X50. Z5.
G82 X0 Z-10. R2.
M30
