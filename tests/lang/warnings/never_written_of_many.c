// More locals than a machine word has bits.
int sum;
int t0() {
  int v0, v1, v2, v3, v4, v5, v6, v7, v8, v9, v10, v11, v12, v13;
  int v14, v15, v16, v17, v18, v19, v20, v21, v22, v23, v24, v25, v26, v27;
  int v28, v29, v30, v31, v32, v33, v34, v35, v36, v37, v38, v39, v40, v41;
  int v42, v43, v44, v45, v46, v47, v48, v49, v50, v51, v52, v53, v54, v55;
  int v56, v57, v58, v59, v60, v61, v62, v63, v64, v65, v66, v67, v68, v69;
  if (sum) goto READ;
  v0 = 1;
  v63 = 1;
  v64 = 1;
READ:
  sum = v0 + v63;
  sum = v64 + v0;
  sum = v62 + v0; // expect warning MP133
  sum = v65 + v0; // expect warning MP133
  sum = v69 + v0; // expect warning MP133
  v69 = 1;
  return sum;
}
