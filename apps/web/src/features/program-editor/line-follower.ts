/**
 * Keeps the running line in sight where the lines scroll: in the list beside the stage, or in the
 * sheet on a phone. Where the whole page scrolls, nothing moves. A student who scrolls away stops
 * it until the running line is in sight again, or the next run starts. The focus never moves.
 */

/**
 * A line must run this long before the list follows, so that a flickering line does not shake it.
 */
const STEADY_MS = 200;
/** Margin above and below the line, where the list fades out, in px. */
const MARGIN = { above: 8, below: 28 };
/** Events that only a student causes. Scrolling by code fires only "scroll". */
const READERS_EVENTS = ["wheel", "touchmove", "pointerdown", "keydown", "focusin"];

export class LineFollower {
  readonly #list: HTMLElement;
  #isFollowing = true;
  #line: HTMLElement | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #restTimer: ReturnType<typeof setTimeout> | undefined;

  /** @param list the lines; the list or an ancestor scrolls */
  constructor(list: HTMLElement) {
    this.#list = list;
    for (const type of READERS_EVENTS) {
      document.addEventListener(type, this.#leaveAlone, { passive: true });
    }
    document.addEventListener("scroll", this.#awaitRest, { passive: true, capture: true });
  }

  /** Starts a run. The list follows again, whatever the student did before. */
  begin(): void {
    this.#isFollowing = true;
    this.show(this.#line);
  }

  /** Sets the running line, or none. */
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

  /**
   * Scrolling passes positions where the line is in sight. Only the position where the list stops
   * counts.
   */
  readonly #awaitRest = (): void => {
    clearTimeout(this.#restTimer);
    if (!this.#isFollowing) this.#restTimer = setTimeout(this.#lookAgain, STEADY_MS);
  };

  readonly #lookAgain = (): void => {
    // While no line runs, none is in sight.
    if (this.#line !== null && this.#hidden() === 0) this.#isFollowing = true;
  };

  readonly #bringIntoSight = (): void => {
    // A field with the focus must not move away.
    if (!this.#isFollowing || this.#list.contains(document.activeElement)) return;
    // A card at the upper end explains the line, and the student reads it first.
    if (this.#scroller()?.querySelector("[data-card]")) return;
    const hidden = this.#hidden();
    if (hidden !== 0) this.#scroller()?.scrollBy({ top: hidden, behavior: "instant" });
  };

  /** How far to scroll to show the whole line, in px. Negative is up. */
  #hidden(): number {
    const scroller = this.#scroller();
    if (this.#line === null || scroller === null) return 0;
    const box = scroller.getBoundingClientRect();
    const line = this.#line.getBoundingClientRect();
    const above = line.top - MARGIN.above - box.top;
    const below = line.bottom + MARGIN.below - box.bottom;
    if (above < 0) return above;
    // If a line is taller than the list, its top has priority.
    return below > 0 ? Math.min(below, above) : 0;
  }

  /**
   * The element that scrolls the lines in this layout; null if only the page scrolls, or nothing.
   */
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
