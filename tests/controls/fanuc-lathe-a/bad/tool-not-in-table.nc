(expected: 2:1 tool 9 is not in the tool table)
T0909
M30
