(expected: 7:1 G4 and a motion in one block)
T0101 S500 M3 F.2
G0 X50. Z5.
G71 U2. R1.
G71 P10 Q20
N10 G0 X30.
G4 X1. Z2.
N20 X50.
M30
