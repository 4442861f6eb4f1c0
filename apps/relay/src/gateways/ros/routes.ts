/** Ordinary requests to the URL of the ROS gateway, which is a WebSocket. */
import { Router } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import type { GatewayName } from "@corridor/protocol";
import { refuseDisabled } from "../requests/gateway-requests.ts";

const PATH = "/r/:id/ros";

/** @param gateways those that the operator has not switched off */
export function rosRoutes(gateways: readonly GatewayName[]): Router {
  const router = Router();
  if (!gateways.includes("ros")) return router.use(PATH, refuseDisabled("ros"));
  return router.use(PATH, () => {
    throw new Refusal(
      "bad-request",
      "This is the URL of a WebSocket for ROS clients. Connect to it with ws:// or wss://.",
    );
  });
}
