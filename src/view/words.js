"use strict";

/** What the page says, Spanish and English. */
const WORDS = {
  program: ["Programa", "Program"],
  otherLanguage: ["Switch to English", "Cambiar a español"],
  stage: ["Pieza y trayectoria", "Part and path"],
  drawing: ["Vista de la pieza, la herramienta y la trayectoria", "View of part, tool and path"],
  cameras: ["Cámaras", "Cameras"],
  layers: ["Capas", "Layers"],
  notes: ["Avisos", "Notes"],
  playing: ["Reproducción", "Playing"],
  scrub: ["Momento del programa", "Moment of the program"],
  first: ["Al principio (Inicio)", "To the beginning (Home)"],
  back: ["Un movimiento atrás (←)", "One motion back (←)"],
  play: ["Reproducir o pausar (espacio)", "Play or pause (space)"],
  forward: ["Un movimiento adelante (→)", "One motion forward (→)"],
  last: ["Al final (Fin)", "To the end (End)"],
  speed: ["Velocidad", "Speed"],
  machine: ["Máquina y programa", "Machine and program"],
  readout: ["Pantalla de la máquina", "Machine display"],
  tabs: ["Paneles", "Panels"],
  blocks: ["Bloques", "Blocks"],
  remarks: ["Avisos", "Findings"],
  oneNote: ["nota", "note"],
  someNotes: ["notas", "notes"],
  deep: ["profundidad", "depth"],
  help: ["Ayuda", "Help"],
  wanted: ["N60, línea o texto", "N60, line or text"],
  go: ["Ir", "Go"],
  list: ["Bloques del programa", "Blocks of the program"],
  nowhere: ["no se encuentra", "not found"],
  line: ["línea", "line"],
  noRemarks: ["Sin avisos.", "No findings."],
  limit: ["límite", "limit"],
  free: ["Libre", "Free"],
  iso: ["Isométrica", "Isometric"],
  plan: ["Planta", "Plan"],
  planZX: ["Planta (Z-X)", "Plan (Z-X)"],
  front: ["Alzado", "Front"],
  side: ["Perfil", "Side"],
  above: ["Desde +X", "From +X"],
  face: ["Cara", "Face"],
  section: ["Sección", "Section"],
  rapid: ["Rápido", "Rapid"],
  feed: ["Avance", "Feed"],
  thread: ["Rosca", "Thread"],
  rest: ["Trayectoria restante", "Remaining path"],
  grid: ["Rejilla", "Grid"],
  tool: ["Herramienta", "Tool"],
  part: ["Pieza", "Part"],
  fixtures: ["Plato y contrapunto", "Chuck and tailstock"],
  assumedRapid: ["Rápidos supuestos a 6000 mm/min", "Rapids assumed at 6000 mm/min"],
  assumedFeed: ["Sin avance programado: se suponen 300 mm/min", "No feed programmed: 300 mm/min assumed"],
  flat: ["Sin WebGL: dibujo sencillo", "No WebGL: plain drawing"],
  empty: ["El programa no mueve nada", "The program moves nothing"],
  helpText: [
    [
      ["espacio", "reproducir o pausar"],
      ["← →", "un movimiento atrás o adelante; con Mayús, cien"],
      ["↑ ↓", "bloque anterior o siguiente"],
      ["RePág AvPág", "pasada anterior o siguiente"],
      ["Inicio Fin", "al principio o al final"],
      ["+ -", "más rápido o más lento"],
      ["1 … 6", "cámaras, por orden"],
      ["F", "encajar todo en la vista"],
      ["S", "sección"],
      ["/", "buscar un bloque"],
      ["L", "idioma"],
      ["?", "esta ayuda"],
      ["arrastrar", "girar la vista; con el botón derecho o Mayús, desplazarla"],
      ["rueda", "acercar o alejar"],
      ["un dedo", "girar"],
      ["dos dedos", "desplazar y acercar"],
      ["doble clic o toque", "encajar todo en la vista"],
      ["clic en un bloque", "ir a su primer movimiento"],
    ],
    [
      ["space", "play or pause"],
      ["← →", "one motion back or forward; with Shift, a hundred"],
      ["↑ ↓", "previous or next block"],
      ["PgUp PgDn", "previous or next pass"],
      ["Home End", "to the beginning or the end"],
      ["+ -", "faster or slower"],
      ["1 … 6", "cameras, in order"],
      ["F", "fit everything into the view"],
      ["S", "section"],
      ["/", "search for a block"],
      ["L", "language"],
      ["?", "this help"],
      ["drag", "turn the view; with the right button or Shift, move it"],
      ["wheel", "zoom in or out"],
      ["one finger", "turn"],
      ["two fingers", "move and zoom"],
      ["double click or tap", "fit everything into the view"],
      ["click on a block", "go to its first motion"],
    ],
  ],
  helpEnd: [
    "La página va al ritmo de la máquina: cada movimiento dura lo que marca su avance. La trayectoria hecha se ve intensa; la que falta, tenue.",
    "The page plays in machine time: each motion takes as long as its feed says. The finished part of the path is bold, the rest faint.",
  ],
};

let language = document.documentElement.lang === "es" ? "es" : "en";

/** A word of the page in the language in force. */
const say = (key) => WORDS[key][language === "es" ? 0 : 1];
/** A text of the scene in the language in force. */
const pick = (text) => text[language];
const byId = (id) => document.getElementById(id);

/** Puts every fixed word of the page into the language in force. */
function speak() {
  document.documentElement.lang = language;
  for (const element of document.querySelectorAll("[data-t]")) element.textContent = say(element.dataset.t);
  for (const element of document.querySelectorAll("[data-label]")) {
    element.setAttribute("aria-label", say(element.dataset.label));
    if (element.tagName === "BUTTON") element.title = say(element.dataset.label);
  }
  for (const element of document.querySelectorAll("[data-hint]")) element.placeholder = say(element.dataset.hint);
  byId("language").textContent = language === "es" ? "EN" : "ES";
}

/** An element with a class, a text, and a parent. */
function make(tag, parent, text, name) {
  const element = document.createElement(tag);
  if (text !== undefined) element.textContent = text;
  if (name) element.className = name;
  if (parent) parent.append(element);
  return element;
}
