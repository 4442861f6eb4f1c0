/** Tells when the page's colours, words or fonts may have changed: another theme or language, or the system's. */

/** @returns a function that ends it */
export function watchTheme(onChange: () => void): () => void {
  const root = document.documentElement;
  const observer = new MutationObserver(onChange);
  observer.observe(root, {
    attributes: true,
    attributeFilter: ["data-theme", "data-contrast", "lang"],
  });
  const wishes = ["(prefers-color-scheme: dark)", "(forced-colors: active)"].map((query) =>
    window.matchMedia(query),
  );
  for (const wish of wishes) wish.addEventListener("change", onChange);
  return () => {
    observer.disconnect();
    for (const wish of wishes) wish.removeEventListener("change", onChange);
  };
}

/**
 * Custom properties as the page shows them now. Forced colours have names, and what a worker draws by these
 * names is the system's light colours, whatever the reader chose: it gets what they are here.
 */
export function shownProperties(): (property: string) => string {
  const style = getComputedStyle(document.documentElement);
  return (property) => {
    const value = style.getPropertyValue(property);
    if (!/^ ?[A-Z][A-Za-z]+$/.test(value)) return value;
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.color = value;
    const { color } = getComputedStyle(probe);
    probe.remove();
    return color;
  };
}

/** Tells when the window moves to a screen of another pixel density. @returns a function that ends it */
export function watchPixelRatio(onChange: (pixelRatio: number) => void): () => void {
  let query: MediaQueryList | null = null;
  const listen = (): void => {
    query?.removeEventListener("change", listen);
    query = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    query.addEventListener("change", listen);
    onChange(window.devicePixelRatio);
  };
  listen();
  return () => query?.removeEventListener("change", listen);
}
