
/** A number with so many decimals and no minus before nothing. */
function decimals(value, places) {
  if (Number.isNaN(value)) return "–";
  const text = value.toFixed(places);
  return /^-0\.?0*$/.test(text) ? text.slice(1) : text;
}

/** A time in hours, minutes, seconds. */
function clock(seconds) {
  const tenths = Math.round(seconds * 10), whole = Math.floor(tenths / 10);
  const [hours, minutes, rest] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (value) => String(value).padStart(2, "0");
  return `${hours ? `${hours}:${two(minutes)}` : minutes}:${two(rest)}.${tenths % 10}`;
}

const SYSTEMS = ["G53", "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"];

/** The machine's display. */
class Readout {
  show(run) {
    this.run = run;
    this.fields = [];
    const axes = byId("axes");
    axes.replaceChildren();
    const letters = run.readout(run.count ? 0 : -1, 0).map(([letter]) => letter);
    axes.className = letters.length > 3 ? "many" : "";
    for (const letter of letters) {
      const row = make("div", axes);
      make("b", row, letter);
      this.fields.push([make("span", row), make("small", row)]);
    }
    const technology = byId("technology");
    technology.replaceChildren();
    // The cutting speed has a row of its own, so that nothing moves when it comes into force.
    this.technology = (run.data.diameter ? ["S", "V", "F", "T"] : ["S", "F", "T"]).map((letter) => {
      const row = make("div", technology);
      make("b", row, letter);
      return [make("span", row), make("small", row)];
    });
    byId("cells").replaceChildren();
    this.cells = Array.from({ length: 6 }, () => make("span", byId("cells")));
  }

  /** Shows a moment; gives back what the axes say. */
  draw(motion, part) {
    const { run } = this, state = motion < 0 ? null : run.states[run.state[motion]];
    const inch = state?.inch ?? false, said = {};
    const length = (value) => (inch ? decimals(value / 25.4, 4) : decimals(value, 3));
    run.readout(motion, part).forEach(([letter, value, angle], at) => {
      said[letter] = angle ? decimals(value, 3) : length(value);
      this.fields[at][0].textContent = said[letter];
      this.fields[at][1].textContent = angle ? "°" : inch ? "in" : "mm";
    });
    if (!state) return said;
    const rpm = run.rpm(motion, part), feed = run.feed[motion], kind = run.kind[motion], thread = kind === THREAD;
    const turns = state.spindle === 0 ? "0" : rpm === null ? "–" : decimals(rpm, 0);
    const per = thread ? 1 : state.feed, unit = inch ? "in" : "mm";
    const feeds = [inch ? decimals(feed / 25.4, 2) : decimals(feed, 1), length(feed), decimals(feed, 3), decimals(feed, 3)];
    const tool = state.tool === 0 ? "–" : String(state.tool);
    const rows = [
      [turns, "rpm"],
      ...(run.data.diameter ? [[state.surface ? decimals(state.speed, 0) : "–", "m/min"]] : []),
      [feeds[per], [`${unit}/min`, `${unit}/rev`, "1/min", "s"][per]],
      [tool, state.offset ? `${run.data.offset_letter}${state.offset}` : ""],
    ];
    rows.forEach(([value, small], at) => {
      this.technology[at][0].textContent = value;
      this.technology[at][1].textContent = small;
    });
    const codes = run.data.feed_codes;
    const modal = ["G0", "G1", "G2", "G3", codes[0] === "G98" ? "G32" : "G33", "–", "–"][run.modal[motion]];
    const move = kind === DWELL ? `${modal} G4` : modal;
    const cells = [
      [["M5", "M3", "M4"][state.spindle], state.spindle > 0],
      [state.coolant ? "M8" : "M9", state.coolant],
      [SYSTEMS[state.system] ?? "", state.system > 1],
      [codes[state.feed], false],
      [move, run.modal[motion] !== RAPID && !stands(run.modal[motion])],
      [`G${state.compensation}`, state.compensation !== 40],
    ];
    cells.forEach(([text, on], at) => {
      this.cells[at].textContent = text;
      this.cells[at].className = on ? "on" : "";
    });
    Object.assign(said, { S: turns, F: feeds[per], T: tool, cells: cells.map(([text]) => text).join(" ") });
    return said;
  }
}

/** The list of alarms and findings. */
function showRemarks(run, go) {
  const box = byId("remarks"), list = run.data.remarks;
  box.replaceChildren();
  const notes = list.filter((remark) => remark.grade === "note").length;
  byId("count").textContent = `(${list.length - notes})${notes ? ` · ${notes} ${say(notes === 1 ? "oneNote" : "someNotes")}` : ""}`;
  byId("count").className = list.some((remark) => remark.grade === "stop") ? "bad" : "";
  if (list.length === 0) make("p", box, say("noRemarks"));
  for (const remark of list) {
    const button = make("button", box, undefined, remark.grade);
    button.type = "button";
    const code = remark.code ? `${remark.code} · ` : "";
    const where = remark.line ? `${say("line")} ${remark.line}: ` : "", number = remark.number ? `${remark.number} · ` : "";
    make("b", button, `${code}${number}${where}${pick(remark.what)}`);
    const limit = remark.limit ? ` (${say("limit")} ${remark.limit})` : "";
    const at = remark.at ? `X ${decimals(remark.at[0], 3)}  Z ${decimals(remark.at[1], 3)} mm` : "";
    const deep = remark.deep ? `${say("deep")} ` : "";
    const value = remark.value ? `${deep}${remark.value}${limit}` : "";
    if (at || value) make("small", button, [at, value].filter(Boolean).join(" · "));
    if (pick(remark.remedy)) make("small", button, `→ ${pick(remark.remedy)}`);
    button.disabled = !remark.line && remark.motion === null;
    button.addEventListener("click", () => go(remark));
  }
}

function showHelp() {
  const box = byId("help"), table = make("table");
  for (const [key, meaning] of say("helpText")) {
    const row = make("tr", table);
    make("kbd", make("td", row), key);
    make("td", row, meaning);
  }
  box.replaceChildren(table);
  make("p", box, say("helpEnd"));
}

const TABS = ["blocks", "remarks", "help"];

/** Chooses one of the panels. */
function chooseTab(name) {
  for (const tab of TABS) {
    byId(tab).hidden = tab !== name;
    byId(`tab-${tab}`).setAttribute("aria-selected", String(tab === name));
    byId(`tab-${tab}`).tabIndex = tab === name ? 0 : -1;
  }
}
