%P,MX,
;expected: 3:8 K0.5 in G4
N10 G4 K0.5
M30
