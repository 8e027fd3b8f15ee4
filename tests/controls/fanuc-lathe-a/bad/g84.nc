(expected: 4:1 G84 is not supported: tapping, boring)
T0101 S500 M3 F.2
G0 X50. Z5.
G84 X0 Z-10. R2.
M30
