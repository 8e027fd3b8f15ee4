(expected: 5:5 two blocks have the number N10: in lines 6 and 9)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G1 Z-10.
N20 X50.
N10 G0 X60.
M30
