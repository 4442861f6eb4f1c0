/** For tests of what moves by itself: they run without the preference for reduced motion. */
export const withMotion = { contextOptions: { reducedMotion: "no-preference" } } as const;
