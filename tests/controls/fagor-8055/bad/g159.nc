;expected: 3:1 G159 is not supported: work offsets of the table, by N
G71 G90 G94 F100
G159 N1
M30
