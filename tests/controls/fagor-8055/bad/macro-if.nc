; expected: 3:1 macro language that the dialect fagor-8055 does not have
G71 G90 G94 F100
IF [1 EQ 1] GOTO 90
M30
