;expected: 5:1 tool length offset in G18: rodete follows G43 in G17 only
G71 G90 G94 F100
T1 D1
G43 G0 Z50
G18
M30
