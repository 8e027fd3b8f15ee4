(expected: 4:18 Q must be greater than 0)
T0101 S500 M3 F.2
G0 X50. Z5.
G83 X0 Z-10. R2. Q-5
M30
