/** Entry "@corridor/client/host": for the page that owns a robot. */
export {
  HostConnection,
  type CommandJournal,
  type HostConnectionOptions,
  type HostStatus,
} from "./host-connection.ts";
export { globalPlatform } from "./platform.ts";
export { registerRobot, RegistrationError } from "./register-robot.ts";
export { Backoff } from "./backoff.ts";
