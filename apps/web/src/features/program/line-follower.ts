/**
 * Keeps the running line in sight where the lines scroll: beside the stage the list itself, on a phone
 * the sheet around it. Where the whole page scrolls, nothing is moved. Readers who scroll away are left
 * alone until the running line is in sight again or the next run begins; the focus never moves.
 */

/** A line has to run so long before the list follows, so that one that flickers does not shake it. */
const STEADY_MS = 200;
/** Room that is left above the line and below it, where the list fades out, in px. */
const MARGIN = { above: 8, below: 28 };
/** Only a reader makes these; scrolling by code makes just "scroll". */
const READERS_EVENTS = ["wheel", "touchmove", "pointerdown", "keydown", "focusin"];

export class LineFollower {
  readonly #list: HTMLElement;
  #isFollowing = true;
  #line: HTMLElement | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #restTimer: ReturnType<typeof setTimeout> | undefined;

  /** @param list the lines, inside or itself the element that scrolls */
  constructor(list: HTMLElement) {
    this.#list = list;
    for (const type of READERS_EVENTS) {
      document.addEventListener(type, this.#leaveAlone, { passive: true });
    }
    document.addEventListener("scroll", this.#awaitRest, { passive: true, capture: true });
  }

  /** A run begins: whatever the reader did before, the list follows. */
  begin(): void {
    this.#isFollowing = true;
    this.show(this.#line);
  }

  /** The line that runs now, or none. */
  show(line: HTMLElement | null): void {
    this.#line = line;
    clearTimeout(this.#timer);
    if (line !== null) this.#timer = setTimeout(this.#bringIntoSight, STEADY_MS);
  }

  end(): void {
    clearTimeout(this.#timer);
    clearTimeout(this.#restTimer);
    for (const type of READERS_EVENTS) document.removeEventListener(type, this.#leaveAlone);
    document.removeEventListener("scroll", this.#awaitRest, { capture: true });
  }

  readonly #leaveAlone = ({ target }: Event): void => {
    if (target instanceof Node && this.#scroller()?.contains(target)) this.#isFollowing = false;
  };

  /** On its way the list passes places where the line is in sight: what counts is where it comes to rest. */
  readonly #awaitRest = (): void => {
    clearTimeout(this.#restTimer);
    if (!this.#isFollowing) this.#restTimer = setTimeout(this.#lookAgain, STEADY_MS);
  };

  readonly #lookAgain = (): void => {
    // While no line runs, none is in sight.
    if (this.#line !== null && this.#hidden() === 0) this.#isFollowing = true;
  };

  readonly #bringIntoSight = (): void => {
    // A field that is being typed in must not move away.
    if (!this.#isFollowing || this.#list.contains(document.activeElement)) return;
    // A card at the upper end explains the line, and is to be read first.
    if (this.#scroller()?.querySelector("[data-card]")) return;
    const hidden = this.#hidden();
    if (hidden !== 0) this.#scroller()?.scrollBy({ top: hidden, behavior: "instant" });
  };

  /** How far has to be scrolled to show the whole line; negative is up. */
  #hidden(): number {
    const scroller = this.#scroller();
    if (this.#line === null || scroller === null) return 0;
    const box = scroller.getBoundingClientRect();
    const line = this.#line.getBoundingClientRect();
    const above = line.top - MARGIN.above - box.top;
    const below = line.bottom + MARGIN.below - box.bottom;
    if (above < 0) return above;
    // A line that is higher than the list shows its top.
    return below > 0 ? Math.min(below, above) : 0;
  }

  /** What scrolls the lines in this layout; null where it is the page, or nothing. */
  #scroller(): HTMLElement | null {
    let element: HTMLElement | null = this.#list;
    while (element !== null && element !== document.body) {
      const scrolls = element.scrollHeight > element.clientHeight;
      if (scrolls && /auto|scroll/.test(getComputedStyle(element).overflowY)) return element;
      element = element.parentElement;
    }
    return null;
  }
}
