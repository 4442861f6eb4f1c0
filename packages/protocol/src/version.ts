/** Version of the messages between page, relay and scripts. Incremented when a meaning changes. */
export const PROTOCOL_VERSION = 1;
