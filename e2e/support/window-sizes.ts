/**
 * The smallest window with the layout of a computer, for pages whose looks do not matter: a robot
 * that drives in it needs half the processor time.
 */
export const smallWindow = { viewport: { width: 900, height: 600 } };

/** The smallest window whose bar has room for all words. */
export const wideWindow = { viewport: { width: 1200, height: 600 } };

/** For a page that only has to be open, while a script drives its robot. */
export const tinyWindow = { viewport: { width: 160, height: 120 } };
