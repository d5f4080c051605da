/* At the end of an S-function: what Simulink calls. Here it is the test that does. */
void sfunction_sizes(SimStruct *S);
void sfunction_outputs(SimStruct *S);
void sfunction_sizes(SimStruct *S) {
  mdlInitializeSizes(S);
  mdlInitializeSampleTimes(S);
}
void sfunction_outputs(SimStruct *S) {
  mdlOutputs(S, 0);
  mdlTerminate(S);
}
