(expected: 4 Z is missing in G81)
T0101 S500 M3 F.2
G0 X50. Z5.
G81 X0 R2.
M30
