/** Entry "@corridor/client/show": for the big screen of a class. */
export { ShowLink, type ScreenMessage, type ShowLinkOptions } from "./screen-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
