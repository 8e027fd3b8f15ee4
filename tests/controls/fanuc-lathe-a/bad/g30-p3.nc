(expected: 4:5 G30 P3: rodete does not follow the third and fourth reference points)
T0101 S500 M3 F.2
G0 X50. Z5.
G30 P3 U0
M30
