(expected: 7 PS0063: G71: there is no motion from N10 to N20)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 F.1
N20 S500
M30
