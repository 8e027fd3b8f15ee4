
/** The height of a row, and the most that a browser makes of a tall element, in pixels. */
const ROW = 22, TALLEST = 8e6;

/** The list of blocks: only the rows in view are made. */
class BlockList {
  constructor(chosen) {
    this.box = byId("list");
    this.tall = byId("tall");
    this.rows = byId("rows");
    this.chosen = chosen;
    this.made = [];
    this.top = -1;
    this.box.addEventListener("scroll", () => this.draw());
    this.rows.addEventListener("click", (event) => {
      const row = event.target.closest(".row");
      if (row) this.chosen(Number(row.dataset.line));
    });
    new ResizeObserver(() => this.draw(true)).observe(this.box);
  }

  show(run) {
    this.run = run;
    this.marks = new Map();
    for (const remark of run.data.remarks) {
      if (remark.line && remark.grade !== "note" && this.marks.get(remark.line) !== "stop") this.marks.set(remark.line, remark.grade);
    }
    this.line = 0;
    this.tall.style.height = `${Math.min(run.blocks.length * ROW, TALLEST)}px`;
    this.box.scrollTop = 0;
    this.draw(true);
  }

  /** How many rows lie above the view, as a fraction. A list too tall for an element is scrolled in proportion. */
  above() {
    const count = this.run.blocks.length, height = this.box.clientHeight;
    if (count * ROW <= TALLEST) return this.box.scrollTop / ROW;
    return (this.box.scrollTop / (TALLEST - height)) * (count - height / ROW);
  }

  scrollTo(row) {
    const count = this.run.blocks.length, height = this.box.clientHeight;
    this.box.scrollTop = count * ROW <= TALLEST ? row * ROW : (row / (count - height / ROW)) * (TALLEST - height);
  }

  /** Marks a line and brings it into view. */
  mark(line) {
    if (line === this.line) return;
    this.line = line;
    const seen = this.box.clientHeight / ROW, above = this.above();
    if (line === 0) this.scrollTo(0);
    else if (seen > 0 && (line - 1 < above + 1 || line > above + seen - 1)) this.scrollTo(Math.max(0, line - 1 - seen / 2));
    this.draw(true);
  }

  draw(anew = false) {
    if (!this.run) return;
    const count = this.run.blocks.length, seen = Math.ceil(this.box.clientHeight / ROW) + 2;
    const above = this.above(), top = Math.max(0, Math.min(Math.floor(above), count - 1));
    this.rows.style.transform = `translateY(${this.box.scrollTop - (above - top) * ROW}px)`;
    if (!anew && top === this.top && this.made.length >= seen) return;
    this.top = top;
    this.box.removeAttribute("aria-activedescendant");
    while (this.made.length < seen) {
      const row = make("div", this.rows, undefined, "row");
      row.setAttribute("role", "option");
      row.id = `row-${this.made.length}`;
      const number = make("i", row), text = make("span", row);
      this.made.push({ row, number, text });
    }
    this.made.forEach(({ row, number, text }, at) => {
      const line = top + at + 1;
      row.hidden = line > count || at >= seen;
      if (row.hidden) return;
      row.dataset.line = line;
      row.className = `row ${line === this.line ? "now" : ""} ${this.marks.get(line) ?? ""} ${this.run.ofLine[line] < 0 ? "idle" : ""}`;
      row.setAttribute("aria-selected", String(line === this.line));
      row.setAttribute("aria-posinset", line);
      row.setAttribute("aria-setsize", count);
      if (line === this.line) this.box.setAttribute("aria-activedescendant", row.id);
      number.textContent = line;
      text.textContent = this.run.blocks[line - 1];
    });
  }
}
