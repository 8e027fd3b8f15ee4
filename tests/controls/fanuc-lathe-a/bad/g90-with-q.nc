(expected: 4:16 Q word with no code that uses it)
T0101 S500 M3 F.2
G0 X50. Z5.
G90 X48. Z-20. Q180000
M30
