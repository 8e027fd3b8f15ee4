(expected: 4:8 K is not supported: chamfering a corner)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X4. K5.
M30
