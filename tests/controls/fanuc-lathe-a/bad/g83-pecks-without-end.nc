(expected: 4:18 more than 10000 pecks in one hole)
T0101 S500 M3 F.2
G0 X50. Z5.
G83 X0 Z-10. R2. Q1
M30
