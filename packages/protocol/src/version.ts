/** The version of the messages between page, relay and scripts. It rises when a meaning changes. */
export const PROTOCOL_VERSION = 1;
