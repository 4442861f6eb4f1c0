/** Gateways: endpoints for other protocols, which the operator can switch off. */
export const gatewayNames = ["ros", "mcp", "soap"] as const;
export type GatewayName = (typeof gatewayNames)[number];
