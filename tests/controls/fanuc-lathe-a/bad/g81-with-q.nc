(expected: 4:18 Q word with no code that uses it)
T0101 S500 M3 F.2
G0 X50. Z5.
G81 X0 Z-10. R2. Q500
M30
