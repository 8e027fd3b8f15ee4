(expected: 4:16 P word with no code that uses it)
T0101 S500 M3 F.2
G0 X50. Z5.
G2 X40. Z0 R20.P2
M30
