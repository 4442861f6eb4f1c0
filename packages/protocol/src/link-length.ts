/** Longest text of a link after its `#`. In its own file so that the page imports no schemas. */
export const MAX_LINK_LENGTH = 8_192;
