;expected: 3:4 1.5 is not a tool number
G71 G90 G94 F100
T1 D1.5
M30
