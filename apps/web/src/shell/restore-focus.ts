/**
 * Prevents loss of focus. If the focused control is removed or disabled (a closed card, Back to
 * now, the last hint), the browser resets the focus, and keyboard users start again at the top of
 * the page. This module moves it to the nearest remaining control, or to where it was before, or to
 * Run. Loaded with the first key press (`lazy-restore-focus.ts`).
 */

const FOCUSABLE =
  "a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex='-1'])";
/** Groups of controls: beyond them "near" has no meaning. */
const GROUPS = "section, fieldset, dialog, [popover], li, form";
/** Largest number of recorded elements. */
const MAX_PLACES = 12;

/** @returns a function that stops it */
export function restoreFocus(page: Document): () => void {
  const end = new AbortController();
  const { signal } = end;
  /** focused elements with their containers, the newest last */
  let places: { element: HTMLElement; around: Element[] }[] = [];
  /** the user released the focus, by a press on the background or outside of the window */
  let isReleased = true;

  function record(target: EventTarget | null): void {
    if (!(target instanceof HTMLElement)) return;
    // A pointer user needs no focus, and holds a drive key next: restored focus would be in the
    // way.
    isReleased = !target.matches(":focus-visible");
    const others = places.filter(({ element }) => element !== target);
    places = [...others, { element: target, around: containersOf(target) }].slice(-MAX_PLACES);
  }
  // The key press that loaded this module has already moved the focus.
  if (page.activeElement !== page.body) record(page.activeElement);
  page.addEventListener("focusin", ({ target }) => record(target), { signal });
  page.addEventListener(
    "focusout",
    ({ target, relatedTarget }) => {
      if (relatedTarget !== null || !(target instanceof HTMLElement)) return;
      // A control that is being removed is still in the page here.
      queueMicrotask(() => {
        if (page.activeElement === page.body && canTakeFocus(target)) isReleased = true;
      });
    },
    { signal },
  );

  /** A disabled control retains the focus for a moment, and handles no key. */
  function isLost(): boolean {
    const { activeElement } = page;
    return (
      !isReleased && (activeElement === page.body || activeElement?.matches(":disabled") === true)
    );
  }

  function restore(): void {
    const last = places.at(-1);
    if (!isLost() || last === undefined || canTakeFocus(last.element)) return;
    const near = last.around.map(firstIn).find((each) => each !== null);
    const before = places.findLast(({ element }) => canTakeFocus(element))?.element;
    const target = near ?? before ?? page.querySelector<HTMLElement>("[data-does]");
    target?.focus({ preventScroll: true });
  }

  let isDue = false;
  // A closing dialog restores the focus by itself, slightly later.
  const observer = new MutationObserver(() => {
    if (isDue || !isLost()) return;
    isDue = true;
    setTimeout(() => {
      isDue = false;
      restore();
    });
  });
  observer.observe(page.body, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["disabled", "hidden", "open"],
  });
  return () => {
    observer.disconnect();
    end.abort();
  };
}

/** The ancestors of an element, from the inside, up to its group. */
function containersOf(element: Element): Element[] {
  const containers: Element[] = [];
  for (let at = element.parentElement; at !== null; at = at.parentElement) {
    containers.push(at);
    if (at.matches(GROUPS)) break;
  }
  return containers;
}

function firstIn(container: Element): HTMLElement | null {
  if (!container.isConnected) return null;
  return [...container.querySelectorAll<HTMLElement>(FOCUSABLE)].find(canTakeFocus) ?? null;
}

function canTakeFocus(element: HTMLElement): boolean {
  return (
    element.isConnected &&
    !element.matches(":disabled, [inert] *") &&
    element.checkVisibility({ visibilityProperty: true })
  );
}
