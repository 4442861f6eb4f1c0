/** Entry "@corridor/client/host": for the page that owns a robot. */
export {
  HostLink,
  type CommandJournal,
  type HostLinkOptions,
  type HostStatus,
} from "./host-connection.ts";
export { globalPlatform } from "./platform.ts";
export { registerRobot, RegistrationError } from "./register-robot.ts";
export { Backoff } from "./backoff.ts";
