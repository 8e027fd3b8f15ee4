(expected: 4:8 L word with no code)
T0101 S500 M3 F.2
G0 X50. Z5.
G1 X4. L5
M30
