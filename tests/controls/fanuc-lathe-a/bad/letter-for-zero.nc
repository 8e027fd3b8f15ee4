(expected: 3:6 is it the digit 0? Write 0)
G21 G98
G0 X4O. Z2.
M30
