/**
 * Keeps the running line in sight in a list that scrolls. Readers who scroll away are left alone until
 * the running line is in sight again or the next run begins; the focus never moves.
 */

/** A line has to run so long before the list follows, so that one that flickers does not shake it. */
const STEADY_MS = 200;
/** Room that is left above and below the line, in px. */
const MARGIN = 8;

export class LineFollower {
  readonly #list: HTMLElement;
  #isFollowing = true;
  #line: HTMLElement | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  /** @param list the element that scrolls */
  constructor(list: HTMLElement) {
    this.#list = list;
    // Only a reader makes these; scrolling by code makes just "scroll".
    for (const type of ["wheel", "touchmove", "pointerdown", "keydown", "focusin"]) {
      list.addEventListener(type, this.#leaveAlone, { passive: true });
    }
    list.addEventListener("scroll", this.#lookAgain, { passive: true });
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
    for (const type of ["wheel", "touchmove", "pointerdown", "keydown", "focusin"]) {
      this.#list.removeEventListener(type, this.#leaveAlone);
    }
    this.#list.removeEventListener("scroll", this.#lookAgain);
  }

  readonly #leaveAlone = (): void => {
    this.#isFollowing = false;
  };

  readonly #lookAgain = (): void => {
    if (!this.#isFollowing && this.#hidden() === 0) this.#isFollowing = true;
  };

  readonly #bringIntoSight = (): void => {
    // A field that is being typed in must not move away.
    if (!this.#isFollowing || this.#list.contains(document.activeElement)) return;
    const hidden = this.#hidden();
    if (hidden !== 0) this.#list.scrollBy({ top: hidden, behavior: "instant" });
  };

  /** How far the list has to scroll to show the whole line; negative is up. */
  #hidden(): number {
    if (this.#line === null) return 0;
    const list = this.#list.getBoundingClientRect();
    const line = this.#line.getBoundingClientRect();
    const above = line.top - MARGIN - list.top;
    const below = line.bottom + MARGIN - list.bottom;
    if (above < 0) return above;
    // A line that is higher than the list shows its top.
    return below > 0 ? Math.min(below, above) : 0;
  }
}
