/** Entry "@corridor/client/show": for the big screen of a class. */
export {
  ScreenConnection,
  type ScreenMessage,
  type ScreenConnectionOptions,
} from "./screen-connection.ts";
export type { ConnectionStatus } from "./connection.ts";
