;expected: 4:1 G53 without axis words
G71 G90 G94 F100
G1 X5
G53
M30
