(expected: 2:1 offset 9 is not in the tool table)
T0109
M30
