/**
 * Never loses the focus: where the focused control goes or is switched off (a card that is closed, Back to
 * now, the last hint), the browser leaves the focus nowhere, and who has no mouse begins again at the top
 * of the page. Here it goes to the nearest control that is left, else to where it was before, else to Run.
 * Comes with the first key that is pressed (`keep-focus-later.ts`): who presses none needs no focus.
 */

const FOCUSABLE =
  "a[href], button, input, select, textarea, summary, [tabindex]:not([tabindex='-1'])";
/** Containers that belong together: beyond them "near" means nothing. */
const GROUPS = "section, fieldset, dialog, [popover], li, form";
/** Places that are remembered, the newest last. */
const MOST = 12;

/** @returns a function that ends it */
export function keepFocus(page: Document): () => void {
  const end = new AbortController();
  const { signal } = end;
  /** where the focus was, with what was around it then */
  let places: { element: HTMLElement; around: Element[] }[] = [];
  /** the reader has taken the focus away, by a press on nothing or out of the window */
  let isGivenUp = true;

  function note(target: EventTarget | null): void {
    if (!(target instanceof HTMLElement)) return;
    // Who presses with a pointer needs no focus, and holds a drive key next: none is put in their way.
    isGivenUp = !target.matches(":focus-visible");
    const others = places.filter(({ element }) => element !== target);
    places = [...others, { element: target, around: containersOf(target) }].slice(-MOST);
  }
  // The key with which this came has moved the focus already.
  if (page.activeElement !== page.body) note(page.activeElement);
  page.addEventListener("focusin", ({ target }) => note(target), { signal });
  page.addEventListener(
    "focusout",
    ({ target, relatedTarget }) => {
      if (relatedTarget !== null || !(target instanceof HTMLElement)) return;
      // A control that is being taken out of the page is still in it here.
      queueMicrotask(() => {
        if (page.activeElement === page.body && canTakeFocus(target)) isGivenUp = true;
      });
    },
    { signal },
  );

  /** A control that is switched off keeps the focus for a moment, and answers no key. */
  function isLost(): boolean {
    const { activeElement } = page;
    return (
      !isGivenUp && (activeElement === page.body || activeElement?.matches(":disabled") === true)
    );
  }

  function rescue(): void {
    const last = places.at(-1);
    if (!isLost() || last === undefined || canTakeFocus(last.element)) return;
    const near = last.around.map(firstIn).find((each) => each !== null);
    const before = places.findLast(({ element }) => canTakeFocus(element))?.element;
    const target = near ?? before ?? page.querySelector<HTMLElement>("[data-does]");
    target?.focus({ preventScroll: true });
  }

  let isDue = false;
  // A dialog that closes gives the focus back by itself, a little later than it goes.
  const watch = new MutationObserver(() => {
    if (isDue || !isLost()) return;
    isDue = true;
    setTimeout(() => {
      isDue = false;
      rescue();
    });
  });
  watch.observe(page.body, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["disabled", "hidden", "open"],
  });
  return () => {
    watch.disconnect();
    end.abort();
  };
}

/** What is around an element, from the inside, up to the group that it belongs to. */
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
